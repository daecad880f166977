" SPDX-License-Identifier: GPL-3.0-or-later
" Generated from the tables of the program by scripts/manual: do not edit.
" Sarcina: which files are its scripts

autocmd BufNewFile,BufRead *.sarcina set filetype=sarcina
autocmd BufNewFile,BufRead *.in
  \ if search('^\s*\%(species\|create_cells\|read_restart\|grow\|relax\)\s', 'cnw') |
  \   set filetype=sarcina |
  \ endif
