# SPDX-License-Identifier: Apache-2.0
"""What a calculation sheet is made of: numbers, formulas, checks, steps, texts; it imports nothing of an engine."""
