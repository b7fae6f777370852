# SPDX-License-Identifier: Apache-2.0
"""The main screen and its dialogs, one class per file."""
