#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# planted_links.sh CHECK_LINKS...: the tool finds links to a missing file and a missing heading, and missing files that are
# named in code, and accepts good ones, links in code, and links to other sites.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cat > "$work/good.md" <<'END'
# A page: with `code`, twice
[itself](#a-page-with-code-twice) [other](other.md#second-part) [site](https://example.org/missing) [named][one] `[code](missing.md)`

```c
/* [no link](missing.md) */
```

[one]: other.md
END
printf '# Other\n\n## Second part\n' > "$work/other.md"
"$@" "$work/good.md" > "$work/out" || { cat "$work/out"; echo "a good page is refused"; exit 1; }

for link in 'missing.md' 'other.md#third-part' '#no-heading'; do
  printf '# Page\n\n[a link](%s)\n' "$link" > "$work/bad.md"
  if "$@" "$work/bad.md" > "$work/out"; then echo "not found: $link"; exit 1; fi
  grep -qF "$link" "$work/out" || { cat "$work/out"; echo "not named: $link"; exit 1; }
done

printf '# Page\n\nSee `step/common/undo` and `src/step/no_such_file`.\n' > "$work/bad.md"
if "$@" "$work/bad.md" > "$work/out"; then echo "not found: src/step/no_such_file"; exit 1; fi
grep -qF 'src/step/no_such_file' "$work/out"
if grep -qF 'step/common/undo' "$work/out"; then echo "a file that exists is refused"; exit 1; fi
echo "planted links are found"
