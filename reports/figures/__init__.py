# SPDX-License-Identifier: Apache-2.0
"""What a report draws: curves, loci, bars, sketches, on the page itself."""
