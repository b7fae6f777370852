# SPDX-License-Identifier: Apache-2.0
"""A design under edit, without a screen: what was typed, what it gives, how it is kept.  No Textual."""
