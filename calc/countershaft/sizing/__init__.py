# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft sized: the lightest pair of sectors in an envelope, and what other radii and materials would
give."""
