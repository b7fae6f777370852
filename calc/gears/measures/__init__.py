# SPDX-License-Identifier: Apache-2.0
"""What the inspector measures on one wheel, and back: span, balls and pins, chordal thickness, allowances."""
