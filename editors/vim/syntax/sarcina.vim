" SPDX-License-Identifier: GPL-3.0-or-later
" Generated from the tables of the program by scripts/manual: do not edit.
" Sarcina: scripts of the program that grows colonies of microbes

if exists('b:current_syntax')
  finish
endif
syntax case match

syntax keyword sarcinaValue age anchored bridging caps cells cluster clusters compactness
syntax keyword sarcinaValue contact_clusters contacts coordination defects ellipse energy filaments
syntax keyword sarcinaValue filial fmax founder fractal fx fy fz generation gyration hull id layering
syntax keyword sarcinaValue link_age link_strain links mixing nematic orientation outline parent pi
syntax keyword sarcinaValue quati quatj quatk quatw relaxed segregation shapex shapey shapez speed stage
syntax keyword sarcinaValue straightness strain stretch stuck thickness time ux uy uz verticalised
syntax keyword sarcinaValue volume vx vy vz wall x y zmax zmin
syntax match sarcinaValue /\<\%(species\)\>/

syntax keyword sarcinaKeyword abs against along among angle append approx aspect at axes axis background
syntax keyword sarcinaKeyword band bins branch ces clamp coil color contact cvdw cycles density diameter
syntax keyword sarcinaKeyword draw epsilon error every filament file fluid form format fps fraction from g
syntax keyword sarcinaKeyword gap glide hand handover hi in inertia jitter k kappa keep legend length lo
syntax keyword sarcinaKeyword lognormal long map margin mass maxtry method normal observe of orient origin
syntax keyword sarcinaKeyword overlap overwrite pad pairs particles pitch probability radius range rate
syntax keyword sarcinaKeyword ratio reach rel scalebar screen sd seeds short side size skin snap springs
syntax keyword sarcinaKeyword step then to tol tries uniform until upto view vs where within xlabel ylabel
syntax keyword sarcinaKeyword z zoom
syntax match sarcinaKeyword /\<\%(break\|group\|grow\|log\|plot\|relax\|show\|units\)\>/

syntax keyword sarcinaStyle INF all anchor auto balanced bend bio birth block both bs32 ci95 cividis
syntax keyword sarcinaStyle closest coccus collision colony coolwarm count csv custom cylinder damping
syntax keyword sarcinaStyle default dlvo dopri5 draft dynamic equal euler exponential fast first_time
syntax keyword sarcinaStyle flexible front getenv gravity gray grid histogram image inferno internal iso
syntax keyword sarcinaStyle left linear list magma mean midpoint mother movie nearer newton no none now
syntax keyword sarcinaStyle off on one out paper plane planes plasma poisson povray profile r random
syntax keyword sarcinaStyle reference regularised remodel right rk4 rk8pd rkf45 rod si single sphere
syntax keyword sarcinaStyle stick stiffness string table top twist verlet viridis vtk xy xyz yes
syntax match sarcinaStyle /\<\%(link\)\>/

syntax match sarcinaFunction /\<\%(abs\|acos\|asin\|atan\|atan2\|ceil\|ci95\|cos\|count\|defined\|descends\|exp\|floor\|fraction\|hypot\|is_file\|ln\|log10\|max\|mean\|median\|min\|normal\|poisson\|quantile\|random\|round\|sd\|sign\|sin\|sqrt\|sum\|tan\|ternary\)\ze(/
syntax match sarcinaCommand /^\s*\%(accuracy\|analyze\|apropos\|attach\|clear\|create_cells\|delete_cells\|dimension\|division\|dump\|dump_modify\|echo\|edit\|expect\|expect_error\|force\|group\|grow\|growth\|help\|include\|info\|integrator\|link\|log\|neighbor\|plot\|print\|quit\|read_data\|read_restart\|region\|relax\|restart\|run\|save\|seed\|set\|shell\|show\|species\|substratum\|thermo\|thermo_modify\|thermo_style\|threads\|tradeoff\|undo\|undump\|units\|variable\|warn\|watch\|write_data\|write_dump\|write_restart\)\ze\%(\s\|$\)/
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
