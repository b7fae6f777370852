# SPDX-License-Identifier: Apache-2.0
"""Friction of the meshes and the power balance of the whole drive."""
