# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the checks of text. Defines tracked_files FOLDER PATTERN...: the files under version control there, and
# those about to be; in an unpacked archive, all files but the builds.

tracked_files() {
    local folder=$1
    shift
    cd "$folder"
    # the owner of the folder need not be who runs the tests
    if git -c safe.directory='*' rev-parse --git-dir >/dev/null 2>&1; then
        git -c safe.directory='*' ls-files --cached --others --exclude-standard -- "$@" | while IFS= read -r file; do
            [[ -f $file ]] && printf '%s\n' "$file"
        done
    else
        # git's "*.c" reaches into folders, as does find's
        local pattern
        for pattern; do
            find . -path ./build -prune -o -type f -name "$pattern" -print
        done | sed 's|^\./||' | LC_ALL=C sort
    fi
}
