# SPDX-License-Identifier: Apache-2.0
"""What a designer looks up: oils, materials, publications, fits, fatigue, contact, and the tables they stand in."""
