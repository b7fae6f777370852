# SPDX-License-Identifier: Apache-2.0
"""The engineering: numbers in, numbers out.  No screen, no paper, no printing."""
