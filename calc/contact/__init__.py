# SPDX-License-Identifier: Apache-2.0
"""Two flanks in contact, wherever it is asked for: the line of action, Hertz, the warmth of the teeth.  Used by gears and friction."""
