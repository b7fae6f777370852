# SPDX-License-Identifier: Apache-2.0
"""The rival routes from a bearing and its duty to the film (Reynolds, Raimondi-Boyd, ISO 7902, Falz …), in heat
balance."""
