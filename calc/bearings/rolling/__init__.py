# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings as supports of a shaft: sizes, ratings, life, friction, fits."""
