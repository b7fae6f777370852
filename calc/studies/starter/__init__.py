# SPDX-License-Identifier: Apache-2.0
"""A design to begin with, step by step: which balancing an engine calls for, and the tables that carry it out.

Every rule here is one of this program, and the written file names it beside its number: "assumed".  What can be
computed is computed by the parts that judge the design: the envelope by the sizing, the bearings by their search, teeth
and flanks by solving the whole."""
