# SPDX-License-Identifier: Apache-2.0
"""What a report draws: curves, loci, bars, sketches; on its pages, or as pixels for a terminal."""
