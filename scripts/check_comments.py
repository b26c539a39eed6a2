#!/usr/bin/env python3
"""Refuses comments of C++ sources that begin without their noun or have words that mislead."""

import re
import subprocess
import sys

BEGIN = re.compile(r"(What|Which|From|Those|That|Of|As|It|They|Its|Who|Whose|Why|Where|The same)\b")
ANYWHERE = re.compile(r"\b(told|tells?|wherefore|asked for|stands? for|hasty)\b|^< With\b")
COMMENT = re.compile(r"(?<!:)//[/!]?((?:<)? +.*)")

found = within = False  # a comment that goes on
lines = subprocess.check_output(["git", "grep", "-n", "", "*.h", "*.cpp"], text=True)
for line in lines.splitlines():
    file, number, text = line.split(":", 2)
    if comment := COMMENT.search(text):
        begin = None if within and text.strip()[0] == "/" else BEGIN.match(comment[1].lstrip("< "))
        if word := begin or ANYWHERE.search(comment[1]):
            print(f"{file}:{number}: a comment with `{word[0]}`:{comment[1]}")
            found = True
    within = "//" in text
sys.exit(found)
