# SPDX-License-Identifier: Apache-2.0
"""Friction beyond the one operating point: other speeds and temperatures, other constants, other conditions."""
