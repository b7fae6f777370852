# SPDX-License-Identifier: Apache-2.0
"""The helical gear train: geometry, measures, backlash."""
