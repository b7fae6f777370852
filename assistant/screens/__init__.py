# SPDX-License-Identifier: Apache-2.0
"""The main screen, its dialogs and the other screens, each with the lists and actions that only it has."""
