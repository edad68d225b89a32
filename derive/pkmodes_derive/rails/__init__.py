"""Parts of machines with carriages on rails."""
