# SPDX-License-Identifier: Apache-2.0
"""Paper: knows the calculation sheet, knows nothing about any single step."""
