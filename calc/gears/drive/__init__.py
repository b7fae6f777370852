# SPDX-License-Identifier: Apache-2.0
"""The train over speed: what the crank's irregularity does to the teeth, where flanks part, strike, and how hard."""
