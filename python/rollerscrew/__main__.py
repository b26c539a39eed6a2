"""`python -m rollerscrew` is the program `prs`."""

from rollerscrew_cli import main

main()
