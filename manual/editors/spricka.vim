" Vim syntax file for decks of spricka. Made by `spricka editor vim`; do not edit.
" Put it into ~/.vim/syntax/spricka.vim and, into ~/.vim/ftdetect/spricka.vim:
"   autocmd BufRead,BufNewFile *.deck setfiletype spricka
if exists("b:current_syntax")
  finish
endif
syntax case ignore
syntax match sprickaUnknownCard /^\s*\$\w*/
syntax match sprickaCard /^\s*\$\%(DECK\|PARAMETER\|REQUIRE\|INCLUDE\|NET\|ENDNET\|IMPORT\|MESH\|COOR\|ELEMENT\|NSET\|ESET\|FSET\|MATERIAL\|PROPERTY\|FREEDOM\|MPC\|SYMMETRY\|LOAD\|CONTACT\|RIGID\|CRACK\|TIPNET\|VCE\|STEP\|LOADPATH\|SPECTRUM\|INTERACTION\|GROW\|LAW\|TEST\|SWEEP\|CONTROL\|RESTART\|TASK\|OUTPUT\|CHECK\|END\)\>/
syntax match sprickaKey /\<\%(A\|A0\|AINTRINSIC\|AK\|ALONG\|ALPHA\|AMAX\|ANGLE\|AT\|AT0\|AT1\|AUNIT\|AXIS\|BEYOND\|BIAS\|BK\|C\|CASE\|CHECK\|CLASS\|CLIP\|CLOSED\|COMMENT\|CORRECT\|COUNT\|CRACK\|CRACKS\|CTHM\|CTHP\|CYCLES\|DA\|DEPTH\|DIAMETRAL\|DIM\|DIRECTION\|DK0\|DK1\|DKMAX\|DKMIN\|DKTH\|DOF\|DOMAINS\|E\|ENGINE\|ENVIRONMENT\|ESET\|EVERY\|EX\|EY\|FACES\|FACTOR\|FILE\|FINER\|FLIGHTS\|FORCE\|FORM\|FORMAT\|FROM\|FRONT\|GAP\|HIGHEST\|HISTORY\|HOURS\|INTERACTION\|INTERFERENCE\|JOIN\|K1C\|KAPPA\|KC\|KEEP\|KIE\|KMAX\|KMIN\|KTH\|KUNIT\|L\|LAW\|LENGTH\|LINE\|LOWEST\|LX\|LY\|LZ\|M\|MARK\|MASTER\|MATERIAL\|MAXITER\|MEAN\|METHOD\|MINIMUM\|MOUNTED\|MU\|MULTIPLIER\|NAME\|NEGATIVE\|NET\|NORMAL\|NR\|NSET\|NT\|NU\|NX\|NY\|NZ\|OFFSET\|OMIT\|ORDER\|ORIENTATION\|OUTFORCE\|OUTK\|OUTLENGTH\|OUTLIFE\|OUTSTRESS\|P\|PAIRING\|PARAMETER\|PATCH\|PATH\|PHI0\|PM\|POINTS\|Q\|QUARTER\|R\|R1\|RADIUS\|RATIO\|RCL\|READ\|RECOVERY\|REFERENCE\|RHIGH\|RHO\|RHS\|RI\|RINGS\|RLOW\|RMAX\|RMIN\|RO\|SCALE\|SCATTER\|SECTORS\|SEED\|SFLOW\|SHAPE\|SHIFT\|SHOW\|SIZE\|SKIP\|SLAVE\|SMAX\|SOLID\|SOLR\|SOURCE\|SPECTRUM\|STATE\|SUBSTEPS\|SYSTEM\|T0\|T1\|THICK\|THREADS\|TITLE\|TO\|TOL\|TUBE\|TYPE\|UNIT\|VALUES\|VERSION\|W\|WHERE\|WITH\|WRITE\|X0\|X1\|X2\|XH\|Y0\|Y1\|Y2\|YH\|YIELD\|Z0\|Z1\|Z2\|ZONE\)\>\ze\s*=/
syntax match sprickaName /\%(=\s*\)\@<=\h\w*\%(\.\w\+\)*/
syntax match sprickaNumber /\%(\w\|\.\)\@<!\%(\d\+\.\?\d*\|\.\d\+\)\%(e[+-]\?\d\+\)\?\%(\w\|\.\)\@!/
syntax match sprickaUnit /\[[^]]*\]/
syntax region sprickaString start=/'/ end=/'/ oneline
syntax match sprickaComment /!.*/
syntax match sprickaContinuation /^\s*&/
highlight default link sprickaUnknownCard Error
highlight default link sprickaCard Statement
highlight default link sprickaKey Identifier
highlight default link sprickaName Constant
highlight default link sprickaNumber Number
highlight default link sprickaUnit Type
highlight default link sprickaString String
highlight default link sprickaComment Comment
highlight default link sprickaContinuation Special
setlocal commentstring=!\ %s
let b:current_syntax = "spricka"
