# SPDX-License-Identifier: Apache-2.0
"""The main screen (`workbench.py` and the four files beside it), its dialogs, and the other screens."""
