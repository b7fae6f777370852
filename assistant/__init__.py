# SPDX-License-Identifier: Apache-2.0
"""The screen and the command line."""
