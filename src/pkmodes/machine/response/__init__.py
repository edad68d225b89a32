"""What a machine does when it is driven: poles, frequency responses, state space, compliance."""
