# SPDX-License-Identifier: Apache-2.0
"""Whether a report still says what its design gives, and what was laid over it or appended to it."""
