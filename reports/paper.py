# SPDX-License-Identifier: Apache-2.0
"""The sheet of paper and its margins, in points (1/72 inch)."""

PAGE = (595.276, 841.890)  # A4: width, height
LEFT, RIGHT, TOP, BOTTOM = 57.0, 45.0, 57.0, 49.0
WIDTH = PAGE[0] - LEFT - RIGHT
HEIGHT = PAGE[1] - TOP - BOTTOM
