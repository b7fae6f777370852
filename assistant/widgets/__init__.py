# SPDX-License-Identifier: Apache-2.0
"""The parts of the screen: the form with its fields, lists, tables, curves and sketches, in character cells."""
