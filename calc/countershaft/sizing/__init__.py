# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft sized: the lightest pair of sectors in an envelope; other radii and other materials."""
