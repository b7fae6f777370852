# SPDX-License-Identifier: Apache-2.0
"""The crank train: geometry, kinematics, masses, crank angles."""
