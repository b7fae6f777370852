# SPDX-License-Identifier: Apache-2.0
"""Beyond the one operating point: other speeds and temperatures, other constants, other conditions."""
