" SPDX-License-Identifier: GPL-3.0-or-later
" Generated from the tables of the program by scripts/manual: do not edit.
" Sarcina: how its scripts are edited

if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1
setlocal comments=:# commentstring=#\ %s keywordprg=:!man\ sarcina-\%s
let b:undo_ftplugin = 'setlocal comments< commentstring< keywordprg<'
