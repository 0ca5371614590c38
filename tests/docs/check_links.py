"""check_links.py ROOT: every link of the documentation to a file of the project leads somewhere, and every page is reached from docs/README.md."""
import os
import re
import sys


def links_of(page):
    with open(page, encoding="utf-8") as file:
        text = re.sub(r"(?ms)^```.*?^```", "", file.read())
    for target in re.findall(r"\]\(([^)\s]+)\)", text) + re.findall(r'src="([^"]+)"', text):
        if not re.match(r"[a-z]+:|#", target):
            yield os.path.normpath(os.path.join(os.path.dirname(page), target.split("#")[0]))


def main():
    root = sys.argv[1]
    docs = os.path.join(root, "docs")
    pages = {os.path.join(folder, name) for folder, _, names in os.walk(docs) for name in names if name.endswith(".md")}
    broken = [f"{page}: {target}" for page in sorted(pages | {os.path.join(root, "README.md")}) for target in links_of(page)
              if not os.path.exists(target)]
    start = os.path.join(docs, "README.md")
    reached, waiting = {start}, [start]
    while waiting:
        for target in links_of(waiting.pop()):
            if target in pages - reached:
                reached.add(target)
                waiting.append(target)
    lost = [f"{page}: no page leads here from docs/README.md" for page in sorted(pages - reached)]
    print("\n".join(broken + lost) or f"{len(pages)} pages, every link leads somewhere")
    return 1 if broken or lost else 0


if __name__ == "__main__":
    sys.exit(main())
