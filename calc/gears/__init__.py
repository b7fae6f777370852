# SPDX-License-Identifier: Apache-2.0
"""The gear train: geometry, measures, backlash, its place in the engine, profile, and the rating of its teeth."""
