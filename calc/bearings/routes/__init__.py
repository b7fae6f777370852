# SPDX-License-Identifier: Apache-2.0
"""The routes from a bearing and its duty to the film: oil supply, friction and flow, and the thermal balance."""
