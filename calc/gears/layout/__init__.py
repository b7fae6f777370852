# SPDX-License-Identifier: Apache-2.0
"""The train in its place: positions, clearances, phase and marks, forces on the axes."""
