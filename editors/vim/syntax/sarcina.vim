" SPDX-License-Identifier: GPL-3.0-or-later
" Generated from the tables of the program by scripts/manual: do not edit.
" Sarcina: scripts of the program that grows colonies of microbes

if exists('b:current_syntax')
  finish
endif
syntax case match

syntax keyword sarcinaValue age anchored bridging cells cluster clusters compactness contacts defects
syntax keyword sarcinaValue ellipse energy filaments filial fmax founder fractal fx fy fz generation
syntax keyword sarcinaValue gyration hull id links orientation outline parent particles pi quati quatj
syntax keyword sarcinaValue quatk quatw relaxed shapex shapey shapez speed stage strain stretch stuck
syntax keyword sarcinaValue thickness time ux uy uz verticalised volume vx vy vz wall x y zmax zmin
syntax match sarcinaValue /\<\%(species\)\>/

syntax keyword sarcinaKeyword abs append approx aspect axes axis background branch ces clamp color contact
syntax keyword sarcinaKeyword cvdw density diameter draw epsilon every filament file fluid form format fps
syntax keyword sarcinaKeyword fraction g gap glide handover in jitter k kappa keep legend length lognormal
syntax keyword sarcinaKeyword long map mass maxtry method normal orient origin overlap overwrite pad
syntax keyword sarcinaKeyword probability range rate ratio reach rel scalebar screen sd short side size
syntax keyword sarcinaKeyword skin springs step then to tol tries uniform until upto view where within z
syntax keyword sarcinaKeyword zoom
syntax match sarcinaKeyword /\<\%(break\|group\|grow\|relax\|units\)\>/

syntax keyword sarcinaStyle INF all anchor auto balanced bio birth block both bs32 cividis closest
syntax keyword sarcinaStyle coccus collision coolwarm csv custom cylinder damping default dlvo dopri5
syntax keyword sarcinaStyle draft dynamic equal error euler exponential fast first_time front getenv
syntax keyword sarcinaStyle gravity gray grid image inferno internal iso linear list magma midpoint
syntax keyword sarcinaStyle mother movie nearer no none now off on one out pairs paper plane planes
syntax keyword sarcinaStyle plasma poisson povray random reference regularised remodel rk4 rk8pd rkf45
syntax keyword sarcinaStyle rod si single sphere stick string top verlet viridis vtk xy xyz yes
syntax match sarcinaStyle /\<\%(link\|log\)\>/

syntax match sarcinaFunction /\<\%(abs\|acos\|asin\|atan\|atan2\|ceil\|ci95\|cos\|count\|defined\|descends\|exp\|floor\|fraction\|hypot\|is_file\|ln\|log10\|max\|mean\|median\|min\|normal\|poisson\|quantile\|random\|round\|sd\|sign\|sin\|sqrt\|sum\|tan\|ternary\)\ze(/
syntax match sarcinaCommand /^\s*\%(accuracy\|analyze\|apropos\|attach\|clear\|create_cells\|delete_cells\|division\|dump\|dump_modify\|echo\|edit\|expect\|expect_error\|force\|group\|grow\|growth\|help\|include\|info\|integrator\|link\|log\|neighbor\|print\|quit\|read_restart\|region\|relax\|restart\|run\|save\|seed\|set\|shell\|species\|substratum\|thermo\|thermo_modify\|thermo_style\|threads\|undo\|undump\|units\|variable\|warn\|write_dump\|write_restart\)\ze\%(\s\|$\)/
syntax match sarcinaBlock /^\s*\%(break\|continue\|elif\|else\|end\|for\|if\|repeat\|while\)\ze\%(\s\|$\)/

" a number with its unit: 0.75um, 1.23/h, 1e-13N.s/m, 5%
syntax match sarcinaNumber /\%(\k\)\@<![-+]\?\%(\d\+\.\?\d*\|\.\d\+\)\%([eE][-+]\?\d\+\)\?\%(%\|\/\?\a[A-Za-z0-9./^-]*\)\?/
syntax match sarcinaDollar /\$\$\|\$\a\>\|\${\w\+}\|\$([^"']*)/ containedin=sarcinaString
syntax region sarcinaString start=/"/ end=/"/ oneline
syntax region sarcinaString start=/\k\@<!'/ end=/'/ oneline
syntax region sarcinaString start=/"""/ end=/"""/
syntax match sarcinaContinue /&\ze\s*\%(#.*\)\?$/
syntax match sarcinaComment /#.*$/ contains=@Spell

highlight default link sarcinaCommand Statement
highlight default link sarcinaBlock Conditional
highlight default link sarcinaStyle Type
highlight default link sarcinaKeyword Identifier
highlight default link sarcinaValue Constant
highlight default link sarcinaFunction Function
highlight default link sarcinaNumber Number
highlight default link sarcinaDollar PreProc
highlight default link sarcinaString String
highlight default link sarcinaContinue Special
highlight default link sarcinaComment Comment

let b:current_syntax = 'sarcina'
