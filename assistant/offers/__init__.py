# SPDX-License-Identifier: Apache-2.0
"""What can be chosen for a step: `STEP.py` says what it NEEDS and WHY, and has `offer()`.  Used by `contralbero choose` and the session."""
