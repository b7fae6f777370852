# SPDX-License-Identifier: Apache-2.0
"""The screen and the command line: the commands, the session without a screen, the screens, and their widgets."""
