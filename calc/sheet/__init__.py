# SPDX-License-Identifier: Apache-2.0
"""What a calculation sheet is made of; nothing here knows an engine."""
