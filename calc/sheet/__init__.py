# SPDX-License-Identifier: Apache-2.0
"""What a calculation sheet is made of: numbers, formulas, checks, steps, texts; nothing here knows an engine."""
