#!/usr/bin/env bash
# tests/package/check_example_in_root.sh PACKAGE.deb: follows the job for a runner in docs/check.md, line by line as it is
# written there, in a bare Debian 12 that gets nothing but this package. Its cases pass; with a changed golden the job
# fails and leaves its report. Needs a network, and root as installing packages does; about a minute.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../cmake/setup.sh"
source "$root/cmake/debian_root.sh"

(($# == 1)) || fail "Name the package: tests/package/check_example_in_root.sh PACKAGE.deb"
package=$(readlink --canonicalize-existing "$1") || fail "There is no file $1."
[[ $(basename "$package") == ghostforce_*.deb ]] || fail "$package is not called ghostforce_*.deb, as docs/check.md has it."

# block KIND: what stands in the first ```KIND of the document. The job's script is a list in the one of yaml.
block() { awk -v fence="\`\`\`$1" '$0 == fence {inside = 1; next} /^```$/ && inside {exit} inside' "$root/docs/check.md"; }
mapfile -t script < <(block yaml | sed -n '/^  script:$/,/^  [a-z]/s/^    - //p')
golden=$(sed -n '/^ghostforce check .* --update /{p;q}' "$root/docs/check.md")
((${#script[@]} > 1)) && [[ $golden ]] || fail "docs/check.md has no job with a script, or no line that makes a golden."

scratch=$root/build/roots/check-example
trap '"${as_root[@]}" rm -rf --one-file-system "$scratch"' EXIT
"${as_root[@]}" rm -rf --one-file-system "$scratch"
make_debian_root "$scratch/debian12" bookworm --variant=minbase
mkdir "$scratch/project"
cp "$package" "$scratch/project/"

# in_project LINE...: runs these there, and stops at the first that fails, as a runner does.
in_project() {
  local lines
  printf -v lines '%s\n' "$@"
  in_debian_root "$scratch/debian12" --mount "$scratch/project:/project" \
    /usr/bin/env --chdir=/project /bin/bash -e -o pipefail -c "$lines"
}

say "Installing $(basename "$package"), and storing the first golden"
logged check-example in_project "$(block bash)" "${script[@]:0:${#script[@]}-1}" "$golden" ||
  fail_with check-example "The package could not be installed, or the golden not be stored."

say "Running the job as it is written:"
printf '  %s\n' "${script[@]}" >&2
logged check-example in_project "${script[@]}" || fail_with check-example "The job fails, but all of its cases should pass."
grep --quiet 'failures="0"' "$scratch/project/report/junit.xml" || fail "junit.xml does not say that nothing failed."
tail -n 3 "$(log_of check-example)" >&2

say "The same with a changed golden:"
in_project "ghostforce render wall45 --strategy full --size 800x600 --part scene -o pictures/wall45-naive.png"
status=0
logged check-example in_project "${script[@]}" || status=$?
((status == 1)) || fail_with check-example "The job ends with $status, but should end with 1."
grep --quiet 'failures="1"' "$scratch/project/report/junit.xml" || fail "junit.xml does not say that one case failed."
grep '^FAIL' "$(log_of check-example)" >&2
say "The example of docs/check.md runs as it is written."
