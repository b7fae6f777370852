# SPDX-License-Identifier: Apache-2.0
"""What a train loses besides its meshes and the counter-shaft's journals: air, oil, bearings, seals, what is given."""
