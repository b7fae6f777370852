# SPDX-License-Identifier: Apache-2.0
"""The strength of the teeth by ISO 6336: load, influence factors, stresses, what they may be, and screening."""
