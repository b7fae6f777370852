# SPDX-License-Identifier: Apache-2.0
"""Drawings: lines, dimensions and letters, and the workshop sheet in the manner of ISO 128, 129, 5457 and 7200."""
