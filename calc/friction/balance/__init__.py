# SPDX-License-Identifier: Apache-2.0
"""The power balance of the whole drive, closed."""
