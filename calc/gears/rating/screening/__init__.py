# SPDX-License-Identifier: Apache-2.0
"""Screening of the flanks by what the oil does between them: film against micropitting, flash against scuffing.

Advice, not a rating: both methods are made for loads far above those of a train that only turns a balance shaft."""
