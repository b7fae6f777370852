# SPDX-License-Identifier: Apache-2.0
"""Workshop drawings in the manner of ISO 128, 129, 5457 and 7200, from what a design knows: one geometry for paper and for DXF."""
