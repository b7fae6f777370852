# SPDX-License-Identifier: Apache-2.0
"""What other programs take of a solved design, as plain rows and components; `frame.py`: the axes that all have in
common."""
