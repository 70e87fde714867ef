// SPDX-License-Identifier: GPL-3.0-or-later
// Empty: a target has to have a source.
