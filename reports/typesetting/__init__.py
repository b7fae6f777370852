# SPDX-License-Identifier: Apache-2.0
"""How words, formulas and tables are set, and how blocks are broken into pages (`pagination.py`)."""
